"""Wrappers that make a sequence method of any single-image method."""
