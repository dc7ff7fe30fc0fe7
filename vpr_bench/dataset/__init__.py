"""Datasets: cards that describe them, editions that hold their images, and loading one protocol."""
