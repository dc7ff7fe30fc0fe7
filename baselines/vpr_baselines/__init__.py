"""The methods of the benchmark, one module or folder each."""
