"""All the English of a derivation, and no mathematics; `report` puts the steps in order."""
