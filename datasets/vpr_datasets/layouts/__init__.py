"""Layouts: each understands one way in which images and places lie on disk; cards name the one they need."""
