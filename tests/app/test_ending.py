"""SIGTERM ends a command as Ctrl+C does: one line, and a status that says so."""

import signal

import pytest

from game.__main__ import main
from game.app.commands import listing
from game.app.ending import ENDED, STOPPED, Ended, ends_tidily, status_of


def test_sigterm_is_raised_where_the_program_is_and_then_is_the_systems_again():
    before = signal.getsignal(signal.SIGTERM)
    signal.signal(signal.SIGTERM, signal.SIG_DFL)
    try:
        with pytest.raises(Ended), ends_tidily():
            signal.raise_signal(signal.SIGTERM)
        assert signal.getsignal(signal.SIGTERM) is signal.SIG_DFL
    finally:
        signal.signal(signal.SIGTERM, before)


def test_who_listens_already_goes_on_listening():
    heard = []
    before = signal.signal(signal.SIGTERM, lambda number, frame: heard.append(number))
    try:
        with ends_tidily():
            signal.raise_signal(signal.SIGTERM)
        assert heard == [signal.SIGTERM]
    finally:
        signal.signal(signal.SIGTERM, before)


@pytest.mark.parametrize(("why", "status"), [(Ended, 143), (KeyboardInterrupt, 130)])
def test_a_command_that_is_stopped_says_so_in_one_line(why, status, monkeypatch, capsys):
    def stopped(options):
        raise why

    monkeypatch.setattr(listing, "execute", stopped)
    assert main(["list"]) == status
    assert capsys.readouterr().err == "carom: stopped\n"


def test_statuses_are_those_of_a_shell():
    assert (status_of(KeyboardInterrupt()), status_of(Ended())) == (STOPPED, ENDED) == (130, 143)
