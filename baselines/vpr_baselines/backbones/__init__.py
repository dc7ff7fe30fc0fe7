"""Convolutional trunks, frozen, that turn images into feature maps."""
