"""What stands and drives in cities: houses, shops, vehicles, signs, and the roads between them."""
