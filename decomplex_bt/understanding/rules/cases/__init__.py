"""Cases: what is a check, what of, and when it is asked."""
