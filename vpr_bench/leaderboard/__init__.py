"""Leaderboards: stored runs as rows of one file, ranked protocol by protocol, written as tables."""
