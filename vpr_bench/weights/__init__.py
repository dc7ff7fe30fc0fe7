"""Pre-trained weights: cards that say what they are, where they lie on this machine, and reading them safely."""
