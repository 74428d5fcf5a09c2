"""The phrases of an instruction, the gaps they may fill, and how well each fills each."""
