# Was in den Zeichnungen des Berichts steht.

### Zeichnungen

sketch-guide = { $law ->
   *[none] Masse auf einer waagerechten Führung, ohne Reibung
    [stokes] Masse auf einer waagerechten Führung, in einer zähen Flüssigkeit
    [coulomb] Masse auf einer waagerechten Führung, mit trockener Reibung
    [newton] Masse auf einer waagerechten Führung, in einem wirbelnden Medium
}
    .description = Eine Feder verbindet eine Masse mit einer Wand links von ihr. Die Masse ist nach { $side ->
       *[left] links aus der Lage ausgelenkt, in der die Feder entspannt ist, und bewegt sich nach rechts
        [right] rechts aus der Lage ausgelenkt, in der die Feder entspannt ist, und bewegt sich nach links
    }; die Federkraft zeigt in die Richtung der Geschwindigkeit. Gewichtskraft und Normalkraft heben einander auf. { $law ->
       *[none] Es gibt keine Reibung.
        [stokes] Die Reibungskraft greift am Körper an, der Geschwindigkeit entgegen.
        [coulomb] Die Reibungskraft greift dort an, wo die Masse die Führung berührt, der Geschwindigkeit entgegen.
        [newton] Die Reibungskraft greift am Körper an, der Geschwindigkeit entgegen.
    }
sketch-loss = Die Energie, die trockene Reibung in einer halben Periode entzieht
    .description = Oben die Masse am Anfang, die Feder um x0 gedehnt; darunter eine halbe Periode später, die Feder um die kürzere Strecke x1 gestaucht. Neben beiden die Energie der Feder; dazwischen der Weg der Länge x0 + x1 und die Arbeit der Reibung auf ihm.
sketch-stream = Körper in einer Strömung
    .description = Ein Medium strömt von links um einen runden Körper und löst sich hinter ihm in Wirbeln ab. Die Reibungskraft zeigt stromabwärts. Sie hängt von der Dichte des Mediums, der angeströmte Fläche und dem Widerstandsbeiwert ab.
    .density = Dichte $ρ$
    .area = angeströmte Fläche $A$
    .coefficient = Widerstandsbeiwert $c_w$
