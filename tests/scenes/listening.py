"""An ear for tests: what a player of sounds hears of a stage."""

from game.stage import Stage


def heard_in(stage: Stage, frames: list[int]) -> list[tuple[str, float]]:
    """Kinds and speeds of what is heard in frames of so many steps."""
    heard, since = [], -1e-9
    for steps in frames:
        stage.run(steps)
        hearing = stage.scene.hearing()
        heard += [(s.kind, round(s.speed, 6)) for s in hearing.sounds if since < s.time <= hearing.time]
        assert all(-1.0 <= s.pan <= 1.0 for s in hearing.sounds)
        since = hearing.time
    return sorted(heard)
