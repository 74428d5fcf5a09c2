"""Ellipses: orders and cases without their verb or their thing."""
