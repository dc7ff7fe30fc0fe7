"""Maps that are kept on disk: fitted once, asked for places at any later time, and extended."""
