"""Reading and writing files safely: whole or not at all, with digests, and with errors that say what to do."""
