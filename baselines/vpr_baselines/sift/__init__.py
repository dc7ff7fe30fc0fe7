"""SIFT key points: matched one by one, or stacked into one vector."""
