"""From the clauses around the tasks, by three small labels each, to the tree of conditions and branches, and back."""
