"""The exact algebra that the mechanics rests on; nothing here knows of a mechanical problem."""
