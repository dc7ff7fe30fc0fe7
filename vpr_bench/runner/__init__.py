"""Running one method on one protocol, and storing what it answered; no metric is computed here."""
