"""Loaders: each understands one on-disk layout, and cards name the one that theirs needs."""
