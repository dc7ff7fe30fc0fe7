"""The datasets of the benchmark: one card (TOML) each, and the loaders and renderers that the cards name."""
