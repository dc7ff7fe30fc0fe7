"""Clustering a reference sequence: by thresholds, by number, by K-means or by given labels, within limits of size."""
