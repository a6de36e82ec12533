#!/usr/bin/env python3
"""How long whole processes take: start_up.py RUNS COMMAND [::: COMMAND]...

The commands run by turns; printed are the median and the least of their wall-clock and processor
milliseconds, and the ratio of the least processor time to that of the first command.

    tests/benchmark/start_up.py 100 /bin/true ::: build/release/bin/asv-solve --version
"""

import os
import statistics
import sys
import time


def commands_of(words):
    commands = [[]]
    for word in words:
        if word == ":::":
            commands.append([])
        else:
            commands[-1].append(word)
    return commands


def run(command, nowhere):
    """Wall-clock and processor milliseconds."""
    began = time.perf_counter()
    silent = [(os.POSIX_SPAWN_DUP2, nowhere, stream) for stream in (1, 2)]
    child = os.posix_spawnp(command[0], command, os.environ, file_actions=silent)
    _, status, used = os.wait4(child, 0)
    if status != 0:
        sys.exit(f"{' '.join(command)} failed")
    return 1e3 * (time.perf_counter() - began), 1e3 * (used.ru_utime + used.ru_stime)


def main():
    runs, commands = int(sys.argv[1]), commands_of(sys.argv[2:])
    nowhere = os.open(os.devnull, os.O_WRONLY)
    taken = [[run(command, nowhere) for command in commands] for _ in range(runs)]
    print("| command | wall, median (least) | processor, median (least) | least / first |")
    print("|---|---|---|---|")
    first = min(row[0][1] for row in taken)
    for i, command in enumerate(commands):
        wall, processor = ([row[i][kind] for row in taken] for kind in (0, 1))
        print(f"| `{' '.join(command)}` | {statistics.median(wall):.2f} ({min(wall):.2f}) "
              f"| {statistics.median(processor):.2f} ({min(processor):.2f}) "
              f"| {min(processor) / first:.2f} |")


if __name__ == "__main__":
    main()
