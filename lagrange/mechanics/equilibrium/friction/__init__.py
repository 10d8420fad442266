"""Friction at rest: where it can hold a system, impending motion, rolling without slip."""
