"""Position based dynamics: rigid links (C14) and soft springs (C15)."""
