"""Methods: what they must be able to do, what they may be able to do, and how they are made from parameters."""
