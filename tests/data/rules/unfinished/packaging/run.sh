echo hello  # XXX
