"""Two small networks (extra `encoder`): one for tasks and arguments instead of CRFs, one for the flow beside them."""
