"""The two-stage system: stage one picks clusters, components of stage two pick images, re-ranking decides."""
