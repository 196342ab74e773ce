"""One periodic orbit, or one at each of many parameter points: solved, refined, judged."""
