"""The optional interpreter on a small pretrained encoder (extra `encoder`): a network instead of features and CRFs."""
