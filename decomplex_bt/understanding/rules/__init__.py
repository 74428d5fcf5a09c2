"""What English settles of an instruction, whatever a model finds likelier; a module for each kind of turn of phrase."""
