"""What English settles of an instruction, whatever a model finds likelier; of tasks (`facts`) and of arguments
(`amendments`), which apply what the folders here know of one kind each."""
