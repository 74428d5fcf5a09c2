"""Background: what is said only so that the rest is understood: accounts, guesses, plans, purposes, hearsay."""
