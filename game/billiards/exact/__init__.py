"""The exact table: from event to event, without time steps."""
