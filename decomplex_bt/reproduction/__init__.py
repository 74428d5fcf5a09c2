"""The DeComplex paper's experiments on our data: its systems, its measures, its figures beside ours."""
