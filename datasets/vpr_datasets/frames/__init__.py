"""Lists of frames, facts about datasets that are too long for a card."""
