"""What accuracy costs in time: studies, references, reports."""
