"""From stored runs to what people read: rows, tables, curves."""
