"""The thesis's way: a whole network for every part, which a query passes through one after the other."""
