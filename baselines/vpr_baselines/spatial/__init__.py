"""Comparing images cell by cell: what looks alike, and whether it has moved the same way."""
