"""What `burnish chart` is made of: the fixed benchmark set, its measurement, the table and the picture."""
