"""Progress bars: tqdm where it is installed, nothing where it is not."""
from __future__ import annotations

from contextlib import contextmanager
from typing import Any, Callable, Iterator, Optional, Union

Callback = Callable[[str, float], Any]
Progress = Union[None, bool, Callback]


@contextmanager
def callback(progress: Progress) -> Iterator[Optional[Callback]]:
    """What the compiled part is to call for the parameter `progress`: None or False, nothing; True, a bar of tqdm;
    a function, this one, with the name of the phase and its share that is done, in [0, 1]."""
    if progress is None or progress is False:
        yield None
        return
    if progress is not True:
        yield progress
        return
    try:
        from tqdm.auto import tqdm  # type: ignore
    except ImportError:
        yield None
        return
    bar = None

    def show(phase: str, fraction: float) -> None:
        nonlocal bar
        if bar is None or bar.desc != phase + ": ":
            if bar is not None:
                bar.close()
            bar = tqdm(total=1.0, desc=phase, leave=False, bar_format="{desc}: {percentage:3.0f}%|{bar}| {elapsed}")
        bar.update(max(fraction - bar.n, 0))

    try:
        yield show
    finally:
        if bar is not None:
            bar.close()
