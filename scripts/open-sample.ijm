run("Knotted Filament");
