"""Benchmarks of the harness itself: how long, and in how much memory."""
