"""A window on the screen for `human` rendering; without a screen it works as well, and nobody sees it."""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager
from weakref import WeakSet

import pygame

from decomplex_bt.errors import InputError

FRAMES_PER_SECOND = 30
TITLE = "decomplex-bt"
UNSEEN = ("offscreen", "dummy")
"""What SDL falls back to without a word where it finds no screen."""


_open: WeakSet[Window] = WeakSet()


class Window:
    """Shows pictures of one size (pixels), at most `FRAMES_PER_SECOND` a second; closing it hides it for good.

    There may be several at once, each of its own. Raises `InputError` where none can be opened.
    """

    def __init__(self, size: tuple[int, int]) -> None:
        try:
            pygame.display.init()
            self._window: pygame.Window | None = pygame.Window(TITLE, size)
        except pygame.error as error:
            raise _no_window(str(error)) from None
        self._clock = pygame.time.Clock()
        _open.add(self)

    def show(self, picture: pygame.Surface) -> None:
        """Puts a picture on the screen; does nothing after the user has closed the window."""
        _close_those_left()
        if self._window is None:
            return
        self._window.get_surface().blit(picture, (0, 0))
        self._window.flip()
        self._clock.tick(FRAMES_PER_SECOND)

    def close(self) -> None:
        if self._window is None:
            return
        self._window.destroy()
        self._window = None
        _open.discard(self)
        if not _open and pygame.display.get_surface() is None:  # else it is somebody's yet
            pygame.display.quit()


def _close_those_left() -> None:
    """Closes the windows that the user has closed; whoever asks is told of all of them."""
    if not _open:
        return
    for event in pygame.event.get((pygame.QUIT, pygame.WINDOWCLOSE), pump=True):
        for window in tuple(_open):
            if event.type == pygame.QUIT or event.window is window._window:
                window.close()
    if _open:
        pygame.event.clear()


def check_screen() -> None:
    """Raises `InputError` where a window would be seen by nobody, unless SDL_VIDEODRIVER asks for just that.

    For whoever asks for a window alone: an environment renders for "human" anywhere, as Gymnasium's checker wants it.
    """
    try:
        with _quietly():
            pygame.display.init()
    except pygame.error as error:
        raise _no_window(str(error)) from None
    if pygame.display.get_driver() in UNSEEN and "SDL_VIDEODRIVER" not in os.environ:
        pygame.display.quit()
        raise _no_window("there is no display")


@contextmanager
def _quietly() -> Iterator[None]:
    """Without what the libraries behind SDL write to the process' standard error, past Python."""
    saved, nowhere = os.dup(2), os.open(os.devnull, os.O_WRONLY)
    try:
        os.dup2(nowhere, 2)
        yield
    finally:
        os.dup2(saved, 2)
        os.close(saved)
        os.close(nowhere)


def _no_window(why: str) -> InputError:
    return InputError(f"no window can be opened here: {why}; film instead (rgb_array), or set SDL_VIDEODRIVER=dummy")
