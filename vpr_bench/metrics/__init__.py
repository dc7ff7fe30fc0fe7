"""The numbers that are made of a run's stored answers, offline."""
