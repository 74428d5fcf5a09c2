"""What English settles of an instruction, whatever a model finds likelier; of tasks and of arguments."""
