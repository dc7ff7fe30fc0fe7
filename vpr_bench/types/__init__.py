"""The values that datasets, methods, the runner and the metrics exchange; import them from ``vpr_bench``."""
