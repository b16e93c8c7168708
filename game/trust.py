"""Whether a folder is one that only this user (and root) can change: what code may be taken from.

Machine code that is kept on disk is run as it lies there. So a user that may write it runs any code as the
user that reads it. A checksum does not help, and neither would another format, for the content is code.
"""

from __future__ import annotations

import errno
import os
import stat
from functools import cache
from pathlib import Path

MOST_LINKS = 40  # followed on one way, as in Linux
OTHERS_WRITE = stat.S_IWGRP | stat.S_IWOTH
_ACCESS_LIST = "system.posix_acl_access"


def make_private_folder(folder: Path) -> None:
    """Make a folder and those above it that are missing, for this user alone whatever the mask; OSError."""
    for path in (*reversed(folder.parents), folder):
        if not path.is_dir():
            path.mkdir(mode=0o700, exist_ok=True)


def reason_to_distrust(folder: Path) -> str:
    """Why what lies in an existing folder may be another user's, in a few words; empty if it cannot be.

    Every folder and link on the way from the root must belong to this user or to root. No other user may
    write in it. A folder on the way, but not the last one, may let others write where it is sticky, as
    ``/tmp`` is: there only an owner can rename. Always empty where files have no owners (Windows). OSError
    for what is missing or no folder.
    """
    if not hasattr(os, "geteuid"):
        return ""
    place, waiting = Path("/"), list(reversed(folder.absolute().parts[1:]))
    reason = _reason(place, place.lstat())
    links = 0
    while waiting and not reason:
        part = waiting.pop()
        step = place.parent if part == ".." else place / part
        found = step.lstat()
        if not stat.S_ISLNK(found.st_mode):
            place, reason = step, _reason(step, found)
            continue
        links += 1
        reason = f"{step}: too many links" if links > MOST_LINKS else _reason_of_owner(step, found)
        target = step.readlink()
        if target.is_absolute():
            place = Path("/")
        waiting.extend(reversed(target.parts[1:] if target.is_absolute() else target.parts))
    return reason or _reason(place, place.lstat(), last=True)


def is_private_file(found: os.stat_result) -> bool:
    """True for a regular file that only its owner, this user or root, may write."""
    if not stat.S_ISREG(found.st_mode):
        return False
    if not hasattr(os, "geteuid"):
        return True
    return found.st_uid in (0, os.geteuid()) and not found.st_mode & OTHERS_WRITE


def _reason(folder: Path, found: os.stat_result, last: bool = False) -> str:
    """What is wrong with one folder."""
    if not stat.S_ISDIR(found.st_mode):
        raise NotADirectoryError(errno.ENOTDIR, "Not a directory", str(folder))
    reason = _reason_of_owner(folder, found)
    if reason:
        return reason
    others = found.st_mode & OTHERS_WRITE
    if others == stat.S_IWGRP and _is_own_group(folder, found.st_gid):
        others = 0
    if others and (last or not found.st_mode & stat.S_ISVTX):
        return f"others may write in {folder}"
    return ""


def _reason_of_owner(path: Path, found: os.stat_result) -> str:
    return "" if found.st_uid in (0, os.geteuid()) else f"{path} belongs to another user"


def _is_own_group(folder: Path, group: int) -> bool:
    """True if this user is the only member of a folder's group, as where each user has one of his name.

    Under an access list the bits of the group are those of everybody who is named in it.
    """
    try:
        listed = _ACCESS_LIST in os.listxattr(folder) if hasattr(os, "listxattr") else True
    except OSError:  # a file system without such attributes
        listed = False
    return not listed and _is_group_of_one(group, os.geteuid())


@cache
def _is_group_of_one(group: int, user: int) -> bool:
    try:
        import grp
        import pwd

        person, found = pwd.getpwuid(user), grp.getgrgid(group)
    except (ImportError, KeyError):
        return False
    own = person.pw_gid == group and found.gr_name == person.pw_name
    return own and all(member == person.pw_name for member in found.gr_mem)
