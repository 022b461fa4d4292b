"""What the unit and its readers must agree on: the register map and its blocks as values."""
