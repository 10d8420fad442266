"""What a text has beside equations of motion: chains of values, labels, positions, forces of supports, working."""
