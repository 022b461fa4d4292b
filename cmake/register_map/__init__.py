"""What registers.toml says, checked and turned into other forms."""
