"""Filming an episode: frames to an animated GIF, or to a video where the extra is installed."""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Any

from decomplex_bt.errors import InputError

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

FRAMES_PER_SECOND = 12
STEPS_PER_FRAME = 4
"""Control steps (0.1 s each) between two frames: the film runs five times as fast as the episode."""
LINGER_FRAMES = 24
"""The last picture stays for two seconds."""
MOST_GIF_FRAMES = 800
"""Beyond this every second frame of a GIF is dropped: they are all in memory until it is written."""
GIF_COLOURS = 256
SWATCH = 16
"""[px] Side of the patch that makes a colour count in the palette."""


class Film:
    """A film being taken; `add` each step, `close` at the end, `discard` in any case.

    It is written beside `path` and moved there once it is whole: until then what has that name stays as it is. Raises
    `InputError` at once where the file name or its folder will not do, later where it cannot be written any more.
    """

    def __init__(self, path: Path) -> None:
        self.path = path
        self._take: _Gif | _Video
        if not path.parent.is_dir():
            raise InputError(f"--record {path}: there is no folder {path.parent}; make it first")
        if path.is_dir():
            raise InputError(f"--record {path}: this is a folder; expected the name of a file")
        ending = path.suffix.lower()
        if ending not in (".gif", ".mp4"):
            raise InputError(f"--record {path}: expected a name that ends in .gif or .mp4")
        self._draft = path.with_name(f".{path.stem}.{os.getpid()}{ending}")
        with self._writing():
            self._draft.touch()
            self._draft.unlink()
        self._take = _Gif(self._draft) if ending == ".gif" else _Video(self._draft, path)

    def is_due(self, step: int) -> bool:
        """Whether a frame is taken after this step (from 0)."""
        return step % (STEPS_PER_FRAME * self._take.thinning) == 0

    def add(self, frame: NDArray[np.uint8]) -> None:
        """A frame `(height, width, 3)`."""
        with self._writing():
            self._take.add(frame)

    def close(self, last: NDArray[np.uint8]) -> None:
        """Ends with a frame that stays for a while, and writes the file."""
        with self._writing():
            self._take.close(last)
            self._draft.replace(self.path)

    def discard(self) -> None:
        """Leaves nothing of a film that was not closed."""
        self._take.abandon()
        self._draft.unlink(missing_ok=True)

    @contextmanager
    def _writing(self) -> Iterator[None]:
        try:
            yield
        except OSError as error:
            reason = error.strerror or str(error).strip().partition("\n")[0]
            raise InputError(f"--record {self.path}: cannot be written: {reason}") from None


class _Gif:
    def __init__(self, path: Path) -> None:
        self._path = path
        self._frames: list[Any] = []
        self._palette: Any = None
        self.thinning = 1

    def add(self, frame: NDArray[np.uint8]) -> None:
        from PIL import Image

        picture = Image.fromarray(frame)
        if self._palette is None:
            # one palette for all frames: only what has changed between two of them is written
            self._palette = _palette(picture)
        self._frames.append(picture.quantize(palette=self._palette, dither=Image.Dither.NONE))
        if len(self._frames) >= MOST_GIF_FRAMES:
            del self._frames[1::2]
            self.thinning *= 2

    def close(self, last: NDArray[np.uint8]) -> None:
        self.add(last)
        step = round(1000 / FRAMES_PER_SECOND)
        times = [step] * (len(self._frames) - 1) + [step * LINGER_FRAMES]
        first, *rest = self._frames
        first.save(self._path, save_all=True, append_images=rest, duration=times, loop=0, optimize=False)

    def abandon(self) -> None:
        """Nothing was begun before all is written."""


def _palette(picture: Any) -> Any:
    """Colours for all frames: those of the first, and those that may turn up later."""
    from PIL import Image, ImageDraw

    from decomplex_bt.envs.rendering import style

    colours = [
        *style.COLOURS.values(),
        *style.OF_KIND.values(),
        *style.PEOPLE,
        *style.VERDICTS.values(),
        style.POINTER,
        style.WARM,
        style.SCREEN,
        style.EMBER,
        style.TRAIL,
    ]
    shades = [shade for c in colours for shade in (c, style.darker(c), style.lighter(c))]
    small = picture.resize((picture.width // 2, picture.height // 2), Image.Resampling.NEAREST)
    mosaic = Image.new("RGB", (small.width, small.height + SWATCH * (len(shades) * SWATCH // small.width + 1)))
    mosaic.paste(small)
    draw = ImageDraw.Draw(mosaic)
    columns = small.width // SWATCH
    for number, shade in enumerate(shades):
        left, top = number % columns * SWATCH, small.height + number // columns * SWATCH
        draw.rectangle((left, top, left + SWATCH, top + SWATCH), fill=shade)
    return mosaic.quantize(GIF_COLOURS, method=Image.Quantize.MEDIANCUT)


class _Video:
    thinning = 1

    def __init__(self, path: Path, name: Path) -> None:
        if find_spec("imageio") is None or find_spec("imageio_ffmpeg") is None:
            raise InputError(
                f"--record {name}: .mp4 needs the extra 'video' (pip install 'decomplex-bt[video]'); .gif needs nothing"
            )
        import imageio.v2 as imageio

        self._writer = imageio.get_writer(path, fps=FRAMES_PER_SECOND, macro_block_size=2)

    def add(self, frame: NDArray[np.uint8]) -> None:
        self._writer.append_data(frame)

    def close(self, last: NDArray[np.uint8]) -> None:
        for _ in range(LINGER_FRAMES):
            self._writer.append_data(last)
        self._writer.close()

    def abandon(self) -> None:
        with suppress(OSError):
            self._writer.close()
